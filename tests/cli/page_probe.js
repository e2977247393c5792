// Put at the end of a page by page_in_browser_test.cpp, in a frame as wide as is asked: what a browser makes of the page.
// Tells its parent, a problem a line.
(() => {
  const problems = [];
  const say = (what, element) =>
    problems.push(what + ': ' + element.tagName + ' ' + (element.getAttribute('aria-label') || element.textContent).slice(0, 60));
  const shown = (element) => element.getClientRects().length > 0;

  const root = document.documentElement;
  if (root.scrollWidth > root.clientWidth) problems.push('the page itself scrolls sideways, ' + root.scrollWidth + ' px');

  // What the keyboard reaches, in the order of the page, and each of it can be reached.
  const reached = [...document.querySelectorAll('a[href], input, [tabindex]')];
  for (const element of reached) {
    element.focus();
    if (element.tabIndex !== 0) say('not in the order of the page', element);
    if (document.activeElement !== element) say('cannot be reached', element);
  }
  for (const box of document.querySelectorAll('.wide'))
    if (box.tabIndex !== 0) say('scrolls, and the keyboard does not reach it', box);
  for (const link of document.querySelectorAll('a[href]'))
    if (!document.getElementById(link.getAttribute('href').slice(1))) say('leads nowhere', link);

  for (const picture of document.querySelectorAll('svg')) {
    const box = picture.getBoundingClientRect();
    if (box.width < 300 || box.height < 150) say('too small to read, ' + box.width + ' x ' + box.height, picture.parentElement);
    if (!picture.parentElement.getAttribute('aria-label')) say('a picture without words', picture.parentElement);
  }

  // Contrast (WCAG 2.1, 1.4.3) of every text that is shown, on what is really behind it.
  const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
  const luminance = (colour) =>
    channels(colour).slice(0, 3).map((c) => c / 255)
      .map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (; element; element = element.parentElement) {
      const colour = getComputedStyle(element).backgroundColor;
      if (channels(colour)[3] !== 0) return colour;
    }
    return 'rgb(255, 255, 255)';
  };
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const element = texts.currentNode.parentElement;
    if (!texts.currentNode.data.trim() || element.closest('svg, script') || !shown(element)) continue;
    const [a, b] = [luminance(getComputedStyle(element).color), luminance(behind(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) say('contrast ' + contrast.toFixed(2), element);
  }

  // Filters show as many rows as they promise.
  for (const choice of document.querySelectorAll('input')) {
    choice.click();
    const rows = [...choice.closest('.filtered').querySelectorAll('tbody tr')].filter(shown).length;
    const promised = Number(choice.parentElement.textContent.match(/\((\d+)\)\s*$/)[1]);
    if (rows !== promised) say(rows + ' rows are shown', choice.parentElement);
    choice.closest('fieldset').querySelector('input').click();
  }

  const dark = luminance(getComputedStyle(document.body).backgroundColor) < 0.5;
  problems.push('probed: ' + (dark ? 'dark' : 'light') + ', ' + root.clientWidth + ' px, ' + reached.length + ' reached');
  parent.postMessage(problems.join('\n'), '*');
})();
