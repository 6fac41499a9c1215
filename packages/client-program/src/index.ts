export * from './client-process.ts';
export * from './discover-master.ts';
export * from './joining-options.ts';
export * from './log.ts';
export * from './state-log.ts';
export * from './token-file.ts';
