import { setLucideProps } from '@lucide/vue';

/** One drawing for all icons: 1.5 px lines at every size. Call once, in the root's setup. */
export function provideIconStyle(): void {
  setLucideProps({ size: 16, strokeWidth: 1.5, absoluteStrokeWidth: true });
}
