mod reference;
mod setup;
mod work;
