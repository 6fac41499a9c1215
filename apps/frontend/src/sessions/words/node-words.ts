import { NodeExtensionKind, type NodeInfo, type ProcessingModule } from '@ubii/proto';
import { counted } from '@ubii/words';

const KINDS: Readonly<Record<NodeExtensionKind, string>> = {
  [NodeExtensionKind.EXTERNAL]: 'other program',
  [NodeExtensionKind.MASTER]: 'master',
  [NodeExtensionKind.NODE]: 'Node process',
  [NodeExtensionKind.BROWSER]: 'browser tab',
};

/** Kind of a node, its load and limits: `browser tab, 2 modules`. */
export function nodeHint(node: NodeInfo): string {
  const kind = KINDS[node.node?.kind ?? NodeExtensionKind.EXTERNAL] ?? KINDS[0];
  if (!node.available) return `${kind}, away`;
  const count = node.instances;
  return count === 0 ? kind : `${kind}, ${counted(count, 'module')}`;
}

/** Display name of a node; its id when unknown. */
export function nodeName(
  id: string,
  find: (id: string) => Pick<NodeInfo, 'name' | 'node'> | undefined,
  selfId: string,
): string {
  if (id === '') return 'none yet';
  if (id === selfId) return 'This tab';
  const node = find(id);
  if (node?.node?.kind === NodeExtensionKind.MASTER) return 'Master';
  return node?.name || `${id.slice(0, 8)}…`;
}

/** True when the node can run this module now. [SE-30] */
export function canRun(
  node: NodeInfo,
  module: Pick<ProcessingModule, 'name' | 'onProcessingStringified'> &
    Partial<Pick<ProcessingModule, 'extension'>>,
): boolean {
  if (!node.available) return false;
  if (node.moduleNames.includes(module.name)) return true;
  if (module.extension?.assets.length && node.node?.loadsAssets !== true) return false;
  return module.onProcessingStringified !== '' && node.node?.runsJavascript === true;
}
