export { AssetFolders } from './asset-folders.ts';
export { createNodeSandboxes, type NodeSandboxOptions } from './create-node-sandboxes.ts';
export { createHttpLibrary } from './http-library.ts';
export type { HostLibrary } from '../sandbox/worker-link.ts';
export { defaultModuleMemory, defaultSessionMemory } from './default-memory.ts';
