// Colours are pairs: on paper, and on the ground of readers who prefer dark.
function scheme() {
  return scheme.query ??= matchMedia("(prefers-color-scheme: dark)");
}
function tinted(pair) {
  return pair[Number(scheme().matches)];
}
