export { MATCHES, REFUSED, SLOW_ELSEWHERE, TOO_LARGE } from './pattern-table.ts';
export { patternCompilerSuite } from './pattern-compiler-suite.ts';
