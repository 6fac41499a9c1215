export { Re2Patterns } from './re2-patterns.ts';
