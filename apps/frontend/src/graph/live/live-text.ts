import { createTextVNode, type FunctionalComponent } from 'vue';

/**
 * Text that changes often. Rerenders only itself and keeps its text node: browsers lay out a changed text faster than a
 * new one.
 */
export const LiveText: FunctionalComponent<{ read: () => string | undefined }> = ({ read }) =>
  createTextVNode(read() ?? '');
LiveText.props = ['read'];
LiveText.displayName = 'LiveText';
