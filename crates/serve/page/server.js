// What the server is asked, and what it answers.

/** An answer that is a refusal: what was found, and what would be right. */
export class Refusal extends Error {
  constructor(found, remedy) {
    super(found);
    this.remedy = remedy;
  }
}

/** Asks; an answer in JSON. A request that is aborted throws an AbortError. */
export async function ask(address, body, signal) {
  return (await send(address, body, signal)).json();
}

/** Asks; an answer as a file. */
export async function askForFile(body) {
  return (await send('api/file', body)).blob();
}

async function send(address, body, signal) {
  const request = body === undefined
    ? { signal }
    : { signal, method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
  let response;
  try {
    response = await fetch(address, request);
  } catch (error) {
    if (error.name === 'AbortError') throw error;
    throw new Refusal('The server does not answer.', 'Start peel serve again, and load the page again.');
  }
  if (response.ok) return response;
  const { error, remedy } = await response.json().catch(() => ({ error: response.statusText, remedy: '' }));
  throw new Refusal(error, remedy);
}

/**
 * One request at a time, of which the latest counts: while an answer is awaited, what is asked meanwhile waits, and of that the last alone is
 * sent. An answer that takes longer than `patience` ms is given up for a newer request, which stops its run.
 */
export class Latest {
  constructor(patience) {
    this.patience = patience;
    this.running = null;
    this.next = null;
  }

  /** `work` gets a signal. */
  ask(work) {
    this.next = work;
    if (!this.running) return this.begin();
    const waited = performance.now() - this.running.since;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => { if (this.next) this.running?.abort.abort(); }, Math.max(0, this.patience - waited));
  }

  async begin() {
    while (this.next) {
      const work = this.next;
      this.next = null;
      this.running = { since: performance.now(), abort: new AbortController() };
      await work(this.running.abort.signal);
    }
    this.running = null;
  }
}
