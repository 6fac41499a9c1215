import type { ProcessingModule } from '@ubii/proto';

/** Returns the node that the user chose for a module; empty when the master chooses. [SE-30] */
export function wishedNode({
  nodeId,
  extension,
}: Pick<ProcessingModule, 'nodeId' | 'extension'>): string {
  return extension?.replaceable === true ? '' : nodeId;
}
