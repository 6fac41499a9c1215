import { injectOrThrow } from '../context/inject-or-throw.ts';
import { TAB_NODE, type TabNode } from './tab-node.ts';

/** This tab as a node, provided at the root. */
export function useTabNode(): TabNode {
  return injectOrThrow(TAB_NODE, 'the tab node at the root of the app');
}
