import { nameKeyOf, type TopicNode } from './topic-node.ts';
import type { FindPublisher } from '../names/publisher.ts';

/** Sort criterion on every level; all but the name in descending order. */
export type TopicOrder = 'name' | 'rate' | 'bandwidth' | 'age';

/** True when the order depends on data, so that rows move by themselves. */
export function isRanking(order: TopicOrder): boolean {
  return order !== 'name';
}

/** Sorts the children of a node. */
export function sortChildren(
  node: TopicNode,
  order: TopicOrder,
  findPublisher: FindPublisher,
): TopicNode[] {
  const byName = node.level === 0 ? rootOrder(findPublisher) : compareNames;
  const children = [...node.children.values()];
  if (order === 'name') return children.sort(byName);
  const rank = RANKS[order];
  return children
    .map((child) => ({ child, rank: rank(child) }))
    .sort((a, b) => b.rank - a.rank || byName(a.child, b.child))
    .map(({ child }) => child);
}

/**
 * Rounded values for sorting, so that similar ones do not change places continuously: steps of a tenth for rates, of a
 * quarter for ages.
 */
const RANKS: Readonly<Record<Exclude<TopicOrder, 'name'>, (node: TopicNode) => number>> = {
  rate: ({ hz }) => (hz > 0 ? Math.round(Math.log(hz) / Math.log(1.1)) : -Infinity),
  bandwidth: ({ bytesPerSecond }) =>
    bytesPerSecond > 0 ? Math.round(Math.log(bytesPerSecond) / Math.log(1.1)) : -Infinity,
  // Whole seconds: records within the same second rank equally.
  age: ({ publishedMs }) => Math.floor(publishedMs / 1000),
};

function compareNames(a: TopicNode, b: TopicNode): number {
  return compareText(a.nameKey, b.nameKey) || compareText(a.key, b.key);
}

function compareText(a: string, b: string): number {
  return a < b ? -1 : a > b ? 1 : 0;
}

/** Connected clients first, then topics without a client, then disconnected clients. */
function rootOrder(findPublisher: FindPublisher): (a: TopicNode, b: TopicNode) => number {
  const places = new Map<TopicNode, { readonly group: number; readonly nameKey: string }>();
  const placeOf = (node: TopicNode): { readonly group: number; readonly nameKey: string } => {
    const known = places.get(node);
    if (known) return known;
    const publisher = findPublisher(node.label);
    const place = publisher
      ? { group: publisher.isAway ? 2 : 0, nameKey: nameKeyOf(publisher.name) }
      : { group: 1, nameKey: node.nameKey };
    places.set(node, place);
    return place;
  };
  return (a, b) => {
    const [placeA, placeB] = [placeOf(a), placeOf(b)];
    return (
      placeA.group - placeB.group ||
      compareText(placeA.nameKey, placeB.nameKey) ||
      compareText(a.key, b.key)
    );
  };
}
