import { EXAMPLE_SESSIONS } from '@ubii/modules';
import type { Init, Session } from '@ubii/proto';

/** Example session to start from. */
export interface Template {
  /** Key in `EXAMPLE_SESSIONS`. */
  readonly id: keyof typeof EXAMPLE_SESSIONS;
  /** Purpose, two or three words. */
  readonly title: string;
  /** Visible result, one sentence. */
  readonly sentence: string;
  readonly session: Init<Session>;
  /**
   * Topic with the pointer position, replaced by a live one of a phone or of this browser. Undefined: the session finds
   * pointers itself, or needs none.
   */
  readonly pointerTopic: string | undefined;
  /** True when no data flows until a pointer moves. */
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

/** In order of difficulty. */
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
