export * from './client-process.ts';
export * from './joining-options.ts';
export * from './log.ts';
