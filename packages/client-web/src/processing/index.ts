// Runs processing modules in a client: see README, "Processing modules".

export { createProcessingNode } from './create-processing-node.ts';
export { createPageClock } from './page-clock.ts';
export type { NodeInstance } from './node-instance.ts';
export type { ProcessingNode, ProcessingNodeOptions } from './processing-node.ts';
