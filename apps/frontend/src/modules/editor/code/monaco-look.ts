import type { monaco } from './monaco.ts';

/** Options of every editor of ours. */
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
    // A field is what shortcuts of the page, screen readers and tests know as one
    editContext: false,
    lineDecorationsWidth: 8,
  };
}

/** Monaco measures letters once: it must do so with the face that is shown. */
export async function remeasure(editor: { remeasureFonts(): void }): Promise<void> {
  await document.fonts.load("13px 'JetBrains Mono Variable'");
  editor.remeasureFonts();
}
