// Equations of the site: only the blocks that scripts/docs marks.
window.MathJax = {
  messageStyle: "none",
  showMathMenu: false,
  tex2jax: { inlineMath: [], displayMath: [["\\[", "\\]"]], ignoreClass: ".*", processClass: "arithmatex" },
  CommonHTML: { scale: 92 },
};
