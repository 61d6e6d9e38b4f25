mod presentation;
mod rules;
