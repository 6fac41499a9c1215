import { monaco } from './monaco.ts';

/** Style tokens for Monaco's colours; others are derived from these. */
const COLORS = {
  'editor.background': '--canvas',
  'editor.foreground': '--ink-1',
  'editorLineNumber.foreground': '--ink-3',
  'editorLineNumber.activeForeground': '--ink-1',
  'editorCursor.foreground': '--ink-1',
  'editor.selectionBackground': '--line-2',
  'editor.inactiveSelectionBackground': '--s4',
  'editor.lineHighlightBackground': '--s1',
  'editor.lineHighlightBorder': '--s1',
  'editorIndentGuide.background1': '--line-1',
  'editorIndentGuide.activeBackground1': '--line-2',
  'editorBracketMatch.background': '--s4',
  'editorBracketMatch.border': '--control',
  'editorWidget.background': '--s2',
  'editorWidget.foreground': '--ink-1',
  'editorWidget.border': '--line-2',
  'editorHoverWidget.background': '--s2',
  'editorHoverWidget.border': '--line-2',
  'editorSuggestWidget.background': '--s2',
  'editorSuggestWidget.border': '--line-2',
  'editorSuggestWidget.foreground': '--ink-2',
  'editorSuggestWidget.selectedBackground': '--s4',
  'editorSuggestWidget.selectedForeground': '--ink-1',
  'editorSuggestWidget.highlightForeground': '--live',
  'editorSuggestWidget.focusHighlightForeground': '--live',
  'editorError.foreground': '--err',
  'editorWarning.foreground': '--warn',
  'editorMarkerNavigation.background': '--s2',
  'editorOverviewRuler.border': '--line-1',
  'editorGutter.background': '--canvas',
  'input.background': '--s3',
  'input.foreground': '--ink-1',
  'input.border': '--line-2',
  'list.hoverBackground': '--s3',
  'list.focusBackground': '--s4',
  'menu.background': '--s2',
  'menu.foreground': '--ink-1',
  'menu.selectionBackground': '--s4',
  'menu.selectionForeground': '--ink-1',
  'quickInput.background': '--s2',
  'quickInput.foreground': '--ink-1',
  'scrollbarSlider.background': '--line-2',
  'scrollbarSlider.hoverBackground': '--control',
  'widget.shadow': '--line-1',
  focusBorder: '--ink-1',
  'diffEditor.insertedTextBackground': '--live-tint',
  'diffEditor.insertedLineBackground': '--live-tint',
  'diffEditor.removedTextBackground': '--err-tint',
  'diffEditor.removedLineBackground': '--err-tint',
  'diffEditor.border': '--line-1',
  'diffEditor.unchangedRegionBackground': '--s1',
  'diffEditor.unchangedRegionForeground': '--ink-3',
} as const;

/** The design uses colour for data: syntax is distinguished by a few colours of data format families. */
const TOKENS = {
  '': '--ink-1',
  comment: '--ink-3',
  keyword: '--family-rotation',
  string: '--family-text',
  'string.escape': '--family-objects',
  number: '--family-number',
  regexp: '--family-objects',
  identifier: '--ink-1',
  'type.identifier': '--family-vector',
  delimiter: '--ink-2',
} as const;

/** Returns the current colour of a token in hex, because Monaco does not support `light-dark()`. */
function hexOf(probe: HTMLElement, token: string): string {
  probe.style.color = `var(${token})`;
  const parts =
    getComputedStyle(probe)
      .color.match(/[\d.]+/g)
      ?.map(Number) ?? [];
  const [red = 0, green = 0, blue = 0, alpha = 1] = parts;
  return `#${[red, green, blue, Math.round(alpha * 255)]
    .map((part) => Math.round(part).toString(16).padStart(2, '0'))
    .join('')}`;
}

/** Applies the current style tokens of the page to Monaco. */
export function applyTheme(): void {
  const probe = document.createElement('span');
  document.body.append(probe);
  const colors = Object.fromEntries(
    Object.entries(COLORS).map(([name, token]) => [name, hexOf(probe, token)]),
  );
  const rules = Object.entries(TOKENS).map(([token, color]) => ({
    token,
    foreground: hexOf(probe, color).slice(1, 7),
  }));
  const isDark = parseInt(hexOf(probe, '--canvas').slice(1, 3), 16) < 128;
  probe.remove();
  monaco.editor.defineTheme('ubii', {
    base: isDark ? 'vs-dark' : 'vs',
    inherit: false,
    rules,
    colors,
  });
  monaco.editor.setTheme('ubii');
}

/** Follows the theme of the page. @returns a function that stops it */
export function followTheme(): () => void {
  applyTheme();
  const media = matchMedia('(prefers-color-scheme: dark)');
  const observer = new MutationObserver(applyTheme);
  observer.observe(document.documentElement, { attributeFilter: ['data-theme'] });
  media.addEventListener('change', applyTheme);
  return () => {
    observer.disconnect();
    media.removeEventListener('change', applyTheme);
  };
}
