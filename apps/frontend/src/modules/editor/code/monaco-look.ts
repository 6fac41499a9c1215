import type { monaco } from './monaco.ts';

/** Options of every editor of ours. */
export function editorOptions(): monaco.editor.IEditorOptions {
  const style = getComputedStyle(document.documentElement);
  return {
    fontFamily: style.getPropertyValue('--font-mono').trim(),
    fontSize: 12,
    lineHeight: 19,
    fontLigatures: false,
    // Colour is for data
    bracketPairColorization: { enabled: false },
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
