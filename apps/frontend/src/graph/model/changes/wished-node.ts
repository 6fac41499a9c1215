import type { ProcessingModule } from '@ubii/proto';

/** The node a person chose for a module; empty where the master chooses, whatever it chose. [SE-30] */
export function wishedNode({
  nodeId,
  extension,
}: Pick<ProcessingModule, 'nodeId' | 'extension'>): string {
  return extension?.replaceable === true ? '' : nodeId;
}
