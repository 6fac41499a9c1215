import type { CompiledPattern, PatternCompiler } from '../core/ports/pattern-compiler.ts';

/** The regular expressions of JavaScript, without what RE2 does not know. Not for patterns of strangers. */
export class NativePatterns implements PatternCompiler {
  compile(source: string): CompiledPattern {
    if (/\(\?[=!<]|\\[1-9]/.test(source)) {
      throw new Error('look-around and back-references are not supported');
    }
    const pattern = new RegExp(source, 'u');
    return {
      test: (text) => pattern.test(text),
      match: (text) => pattern.exec(text) ?? undefined,
    };
  }
}
