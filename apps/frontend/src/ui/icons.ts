import { setLucideProps } from '@lucide/vue';

/** Style of all icons: lines of 1.5 px at every size. Call once, in the root's setup. */
export function provideIconStyle(): void {
  setLucideProps({ size: 16, strokeWidth: 1.5, absoluteStrokeWidth: true });
}
