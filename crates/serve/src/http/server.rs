//! The server: an address, its connections, its end.

use crate::asked::limits::Limits;
use crate::http::connections::{BeingAnswered, Busy, Connections};
use crate::http::routes::router;
use crate::page::{StartScene, start_scenes};
use crate::run::runs::Runs;
use axum::Router;
use axum::body::Body;
use axum::http::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::{GracefulShutdown, Watcher};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::runtime::{Builder, Runtime};
use tokio::sync::Notify;

/// How long the server waits after a connection could not be accepted, as where the system has no more files.
const AFTER_A_FAILURE: Duration = Duration::from_millis(50);

/// How long a server that ends waits for the answers that it still owes: each run looks at its end at its next point.
const LAST_ANSWERS: Duration = Duration::from_secs(1);

/// A page that waits for who opens it.
///
/// ```
/// use peelkit_serve::{Limits, Server};
///
/// let server = Server::bind("127.0.0.1".parse()?, 0, None, Limits::default())?;
/// println!("http://{}", server.address());
/// let stopper = server.stopper();
/// std::thread::spawn(move || stopper.stop());
/// server.run();
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    runtime: Runtime,
    runs: Runs,
    limits: Limits,
    routes: Router,
    ended: Arc<Notify>,
}

/// Ends a server from another thread.
#[derive(Clone)]
pub struct Stopper {
    runs: Runs,
    ended: Arc<Notify>,
}

impl Stopper {
    /// Ends the server and the runs that it does.
    pub fn stop(&self) {
        self.runs.end();
        self.ended.notify_one();
    }
}

impl Server {
    /// Takes an address; port 0 is one that is free. The page begins with `own`, the scene of the user, where there is one.
    ///
    /// Fails where the system refuses the address, as where another program has it.
    pub fn bind(address: IpAddr, port: u16, own: Option<StartScene>, limits: Limits) -> io::Result<Self> {
        let listener = TcpListener::bind((address, port))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        let runtime = Builder::new_multi_thread().worker_threads(2).enable_io().enable_time().build()?;
        let runs = Runs::new(limits);
        let routes = router(runs.clone(), limits, start_scenes(own));
        Ok(Self { listener, address, runtime, runs, limits, routes, ended: Arc::default() })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// What ends it.
    pub fn stopper(&self) -> Stopper {
        Stopper { runs: self.runs.clone(), ended: Arc::clone(&self.ended) }
    }

    /// Answers until it is stopped.
    ///
    /// Fails where the system does not let it listen.
    pub fn run(self) -> io::Result<()> {
        let Self { listener, runtime, limits, routes, ended, .. } = self;
        let done = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            let open = Arc::new(GracefulShutdown::new());
            let accepting = tokio::spawn(accept(listener, routes, limits, Arc::clone(&open)));
            ended.notified().await;
            accepting.abort();
            // with it goes its share of what is open
            let _ = accepting.await;
            if let Some(open) = Arc::into_inner(open) {
                // whoever waits for a run gets the message that it ends; who does not read that is left
                let _ = tokio::time::timeout(LAST_ANSWERS, open.shutdown()).await;
            }
            Ok(())
        });
        runtime.shutdown_background();
        done
    }
}

/// Accepts connections for ever.
async fn accept(listener: tokio::net::TcpListener, routes: Router, limits: Limits, open: Arc<GracefulShutdown>) {
    let connections = Connections::default();
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(AFTER_A_FAILURE).await;
            continue;
        };
        if connections.make_room(limits.connections) {
            let busy = Busy::default();
            let task = tokio::spawn(answer(stream, routes.clone(), Arc::clone(&busy), limits, open.watcher()));
            connections.add(busy, task.abort_handle());
        }
    }
}

/// Answers the requests of one connection. Where it is closed before an answer is there, its run is asked to end.
async fn answer(stream: TcpStream, routes: Router, busy: Busy, limits: Limits, open: Watcher) {
    let routes = TowerToHyperService::new(routes);
    let service = service_fn(move |request: Request<Incoming>| {
        let answered = BeingAnswered::new(&busy);
        let response = routes.call(request.map(Body::new));
        async move {
            let response = response.await;
            drop(answered);
            response
        }
    });
    let mut server = http1::Builder::new();
    server.timer(TokioTimer::new()).header_read_timeout(limits.head).max_buf_size(limits.head_size);
    // that a browser closes a connection, or sends no request, is nothing to report
    let _ = open.watch(server.serve_connection(TokioIo::new(stream), service)).await;
}
