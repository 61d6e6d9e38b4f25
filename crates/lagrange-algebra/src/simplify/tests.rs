mod presentation;
mod rules;
mod waves;
