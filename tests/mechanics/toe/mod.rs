mod pad;
mod reference;
mod setup;
mod work;
