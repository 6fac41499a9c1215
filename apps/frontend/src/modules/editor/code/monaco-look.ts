import type { monaco } from './monaco.ts';

/** Options common to all editors. */
export function editorOptions(): monaco.editor.IEditorOptions {
  const style = getComputedStyle(document.documentElement);
  return {
    fontFamily: style.getPropertyValue('--font-code').trim(),
    fontSize: 13,
    lineHeight: 20,
    fontLigatures: false,
    minimap: { enabled: false },
    scrollBeyondLastLine: false,
    renderLineHighlight: 'line',
    automaticLayout: true,
    fixedOverflowWidgets: true,
    padding: { top: 8, bottom: 8 },
    overviewRulerLanes: 2,
    stickyScroll: { enabled: false },
    smoothScrolling: false,
    cursorBlinking: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'solid' : 'blink',
    lineNumbersMinChars: 3,
    wordWrap: 'on',
    wrappingIndent: 'indent',
    folding: false,
    glyphMargin: false,
    // Use a text area, which page shortcuts, screen readers and tests recognise as a field.
    editContext: false,
    lineDecorationsWidth: 8,
  };
}

/** Monaco measures characters once: do it after the font is loaded. */
export async function remeasure(editor: { remeasureFonts(): void }): Promise<void> {
  await document.fonts.load("13px 'JetBrains Mono Variable'");
  editor.remeasureFonts();
}
