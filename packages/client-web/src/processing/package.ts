// The entry `./processing` of the built package, for Node: it has the worker of modules beside it.

export { defineProcessingModule } from '@ubii/pm-sandbox';
export type { ModuleDefinition } from '@ubii/pm-sandbox';
export * from './index.ts';
export { startModules } from './start-modules.ts';
