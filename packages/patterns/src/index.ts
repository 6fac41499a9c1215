export { compileGlob } from './glob.ts';
export { MeteredPatterns, type MeterOptions } from './metered-patterns.ts';
export {
  DEFAULT_PATTERN_LIMITS,
  type CompiledPattern,
  type PatternCompiler,
  type PatternLimits,
} from './pattern-compiler.ts';
export {
  compilerOf,
  lazyPatterns,
  LazyPatterns,
  readyPatterns,
  type PatternSource,
} from './pattern-source.ts';
export {
  MatchBudgetError,
  remembered,
  type MatchBudget,
  type RememberOptions,
} from './remembered.ts';
