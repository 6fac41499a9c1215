import type { ProcessingModule } from '@ubii/proto';
import { cannotRun, isMaster, offerOf, type Node } from './node.ts';

/** The order in which the master looks for a node [SE-30]; among several of one kind, load decides. */
const KINDS: readonly ((node: Node, module: ProcessingModule) => boolean)[] = [
  (node, module) => node.isDedicated && !isMaster(node) && mayChoose(node) && hasIt(node, module),
  (node) => isMaster(node),
  (node) => !isMaster(node) && node.extension?.acceptsWork === true,
  (node, module) => mayChoose(node) && hasIt(node, module),
];

/**
 * Chooses a node for a module [SE-30].
 * @param loadOf Modules of sessions a node runs now.
 * @returns undefined when no node that is there can run it.
 */
export function chooseNode(
  module: ProcessingModule,
  nodes: readonly Node[],
  loadOf: (node: Node) => number,
): Node | undefined {
  const able = nodes.filter(
    (node) => node.isAvailable && cannotRun(node, module) === undefined && surely(node, module),
  );
  for (const isKind of KINDS) {
    const candidates = able.filter((node) => isKind(node, module));
    if (candidates.length > 0) return leastLoaded(candidates, loadOf);
  }
  return undefined;
}

/** The one with the fewest instances for its capacity; the first of equals. */
function leastLoaded(nodes: readonly Node[], loadOf: (node: Node) => number): Node {
  const share = (node: Node): number => loadOf(node) / (node.extension?.capacity || 1);
  return nodes.reduce((best, node) => (share(node) < share(best) ? node : best));
}

/** Existing clients may run modules that they do not list, but this is not reliable. */
function surely(node: Node, module: ProcessingModule): boolean {
  return node.extension !== undefined || hasIt(node, module);
}

function hasIt(node: Node, module: ProcessingModule): boolean {
  return offerOf(node, module.name) !== undefined;
}

/** A node of ours says whether it may be chosen; others may, as far as they list modules. */
function mayChoose({ extension }: Node): boolean {
  return extension === undefined || extension.acceptsWork;
}
