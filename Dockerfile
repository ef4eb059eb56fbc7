# The command peel alone: docker build -t peel . && docker run --rm -v "$PWD:/work" peel run strip.toml
FROM rust:1-slim AS build
COPY . /peelkit
WORKDIR /peelkit
RUN cargo build --release -p peelkit-cli

FROM debian:stable-slim
COPY --from=build /peelkit/target/release/peel /usr/local/bin/peel
WORKDIR /work
ENTRYPOINT ["peel"]
