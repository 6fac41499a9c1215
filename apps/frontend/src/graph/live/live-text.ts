import { createTextVNode, type FunctionalComponent } from 'vue';

/**
 * Text that changes often. Only this is rendered again, not what stands around it, and its node stays:
 * browsers lay out a changed text faster than a new one.
 */
export const LiveText: FunctionalComponent<{ read: () => string | undefined }> = ({ read }) =>
  createTextVNode(read() ?? '');
LiveText.props = ['read'];
LiveText.displayName = 'LiveText';
