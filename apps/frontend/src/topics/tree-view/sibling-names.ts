import { sortedNames, type SortedNames } from '../../ui/names/distinct-part.ts';
import { nameOf } from '../rows/row-view.ts';
import type { FindPublisher } from '../names/publisher.ts';
import type { TopicNode } from '../tree/topic-node.ts';

/** By the order of the children: a new one is made whenever a child comes, goes or is renamed. */
const names = new WeakMap<readonly TopicNode[], SortedNames>();

/** The names of the rows on the same level under the same branch, for shortening a name among them. */
export function siblingNames(node: TopicNode, findPublisher: FindPublisher): SortedNames {
  const siblings = node.parent?.sorted ?? [];
  let found = names.get(siblings);
  if (found === undefined) {
    found = sortedNames(siblings.map((sibling) => nameOf(sibling, findPublisher)));
    names.set(siblings, found);
  }
  return found;
}
