import { EXAMPLE_SESSIONS } from '@ubii/modules';
import type { Init, Session } from '@ubii/proto';

/** A session to start from. */
export interface Template {
  /** Its key among the example sessions. */
  readonly id: keyof typeof EXAMPLE_SESSIONS;
  /** What it does, two or three words. */
  readonly title: string;
  /** What one sees, one sentence. */
  readonly sentence: string;
  readonly session: Init<Session>;
  /**
   * The topic that takes a pointer: a live one stands in its place, of a phone or of this browser.
   * Undefined: it finds its pointers itself, or needs none.
   */
  readonly pointerTopic: string | undefined;
  /** No values flow before a pointer moves. */
  readonly needsPointer: boolean;
}

const template = (
  id: Template['id'],
  sentence: string,
  { pointerTopic, needsPointer = pointerTopic !== undefined }: Partial<Template> = {},
): Template => ({
  id,
  title: EXAMPLE_SESSIONS[id].name ?? id,
  sentence,
  session: EXAMPLE_SESSIONS[id],
  pointerTopic,
  needsPointer,
});

/** Simple ones first. */
export const TEMPLATES: readonly Template[] = [
  template('smooth-pointer', 'A 1€ filter removes the jitter of a pointer.', {
    pointerTopic: '/examples/smooth-pointer/pointer',
  }),
  template('mirror-pointer', 'Mirrors a pointer in x or y. Two switches select the axes.', {
    pointerTopic: '/examples/mirror-pointer/pointer',
  }),
  template('gather-pointers', 'A muxer collects the pointers of all clients.', {
    needsPointer: true,
  }),
  template('smoothing-chain', 'A chain of four modules without inputs.'),
];
