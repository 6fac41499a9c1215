export * from './atomic-files.ts';
export * from './option.ts';
export * from './run-program.ts';
export * from './kinds-of-options.ts';
export * from './program-files.ts';
export * from './read-options.ts';
export * from './stopping.ts';
