//! A server on a free port, and a client that sends what it is told, right or wrong.

use peelkit_serve::{Limits, Server, Stopper};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread::JoinHandle;
use std::time::Duration;

/// The strip of 100 nm.
pub const STRIP: &str = include_str!("../../scenes/strip-100nm.toml");

/// A server that ends with its test.
pub struct Running {
    pub address: SocketAddr,
    stopper: Stopper,
    thread: Option<JoinHandle<std::io::Result<()>>>,
}

/// What came back.
#[derive(Debug)]
pub struct Reply {
    pub status: u16,
    pub head: String,
    pub body: String,
}

impl Reply {
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap_or_else(|error| panic!("{error}: {}", self.body))
    }
}

impl Running {
    pub fn new(limits: Limits) -> Self {
        let server = Server::bind("127.0.0.1".parse().unwrap(), 0, None, limits).unwrap();
        let (address, stopper) = (server.address(), server.stopper());
        Self { address, stopper, thread: Some(std::thread::spawn(move || server.run())) }
    }

    pub fn usual() -> Self {
        Self::new(Limits::default())
    }

    /// Ends the server, as Ctrl-C and SIGTERM do.
    pub fn stop(&self) {
        self.stopper.stop();
    }

    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        stream
    }

    /// Sends bytes as they are, and reads until the server closes the connection.
    pub fn raw(&self, bytes: &[u8]) -> Reply {
        let mut stream = self.connect();
        // the server may answer and close before it has read all
        let _ = stream.write_all(bytes);
        read(&mut stream)
    }

    pub fn get(&self, path: &str) -> Reply {
        self.raw(format!("GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", self.address).as_bytes())
    }

    /// The request of a page, with these headers besides.
    pub fn request(&self, path: &str, body: &str, headers: &str) -> Vec<u8> {
        format!(
            "POST {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Type: application/json\r\n{headers}Content-Length: {}\r\n\r\n{body}",
            self.address,
            body.len()
        )
        .into_bytes()
    }

    pub fn post(&self, path: &str, body: &Value) -> Reply {
        self.raw(&self.request(path, &body.to_string(), ""))
    }

    pub fn is_alive(&self) -> bool {
        self.get("/").status == 200 && self.post("/api/peel", &json!({"name": "a", "scene": STRIP})).status == 200
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.stop();
        if let Some(thread) = self.thread.take() {
            thread.join().unwrap().unwrap();
        }
    }
}

/// One answer, whole. A connection that is closed without one has status 0.
pub fn read(stream: &mut TcpStream) -> Reply {
    let mut bytes = Vec::new();
    // a connection that is reset has said all that it says
    let _ = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let (head, body) = text.split_once("\r\n\r\n").unwrap_or((&text, ""));
    let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
    Reply { status, head: head.to_ascii_lowercase(), body: body.to_owned() }
}
