import type { PatternCompiler } from './pattern-compiler.ts';

/** Provides a compiler: immediately in some programs, loaded on first use in pages. */
export interface PatternSource {
  /** Undefined until it was loaded. */
  readonly compiler: PatternCompiler | undefined;
  /** Rejects when its code cannot be had; the next call tries again. */
  load(): Promise<PatternCompiler>;
}

/** A compiler that is at hand. */
export function readyPatterns(compiler: PatternCompiler): PatternSource {
  return { compiler, load: () => Promise.resolve(compiler) };
}

/** RE2 with the default limits, its code (some 50 KB compressed) loaded when it is asked for. */
export function lazyPatterns(): PatternSource {
  return new LazyPatterns(async () => {
    const { Re2Patterns } = await import('./re2/index.ts');
    return new Re2Patterns();
  });
}

/** A compiler made by `create`, when it is asked for. */
export class LazyPatterns implements PatternSource {
  readonly #create: () => Promise<PatternCompiler>;
  #compiler: PatternCompiler | undefined;
  #loading: Promise<PatternCompiler> | undefined;

  constructor(create: () => Promise<PatternCompiler>) {
    this.#create = create;
  }

  get compiler(): PatternCompiler | undefined {
    return this.#compiler;
  }

  load(): Promise<PatternCompiler> {
    this.#loading ??= this.#create().then(
      (compiler) => (this.#compiler = compiler),
      (error: unknown) => {
        this.#loading = undefined;
        throw error;
      },
    );
    return this.#loading;
  }
}

/** The compiler of a source for those who know that it was loaded. */
export function compilerOf(source: PatternSource): PatternCompiler {
  return {
    compile(text) {
      if (source.compiler === undefined) throw new Error('regular expressions were not loaded yet');
      return source.compiler.compile(text);
    },
  };
}
