import type { NodeInfo } from '@ubii/proto';

/** Value of the option that means the master. */
export const MASTER_RECORDS = 'master';

/** Whether a node can be asked to record now. [RC-60] */
export function isRecorder({ node, available }: Pick<NodeInfo, 'node' | 'available'>): boolean {
  return available && node?.records === true;
}

/** The master first, then the nodes that record. */
export function recorderOptions(
  nodes: readonly NodeInfo[],
): readonly { value: string; text: string; hint?: string }[] {
  const found = nodes.filter((node) => isRecorder(node));
  return [
    { value: MASTER_RECORDS, text: 'This master' },
    ...found.map(({ clientId, name }) => ({ value: clientId, text: name || clientId })),
  ];
}
