import { inject } from 'vue';
import { TAB_NODE, type TabNode } from './tab-node.ts';

/** This tab as a node, provided at the root. */
export function useTabNode(): TabNode {
  const node = inject(TAB_NODE);
  if (!node) throw new Error('useTabNode() needs the tab node at the root of the app.');
  return node;
}
