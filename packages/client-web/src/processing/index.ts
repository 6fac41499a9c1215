// Runs processing modules in a client: see README, "Processing modules".

export type { ProcessingNode, ProcessingNodeOptions } from './create-processing-node.ts';
export { createProcessingNode } from './create-processing-node.ts';
export type { NodeInstance } from './node-instance.ts';
