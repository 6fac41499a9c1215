import type { ServiceName } from '@ubii/proto';
import type { LessonFacts } from './facts.ts';

/** Result of a check. */
export interface Measurement {
  readonly passed: boolean;
  /** Measured value with its unit; empty without one. */
  readonly value: string;
}

/** Examines the running system. */
export interface Check {
  /** Unique within its step. */
  readonly id: string;
  /** The condition, as a sentence without a full stop. */
  readonly text: string;
  /** Instruction, shown until there is a measured value. */
  readonly todo: string;
  measure(facts: LessonFacts): Measurement;
}

/** Effect of "Show answer" in the workspace. */
export type Answer =
  | { readonly kind: 'phones'; readonly count: number }
  /** Simulates a finger that draws a circle on each phone of this page, or taps its centre. */
  | { readonly kind: 'touch'; readonly gesture: 'circle' | 'tap' }
  | { readonly kind: 'move-pointer' }
  /** Adds wires and values to the graph, which is then started or applied. */
  | { readonly kind: 'graph'; readonly edit: GraphAnswer }
  | { readonly kind: 'code'; readonly code: string }
  | { readonly kind: 'try-run' }
  | { readonly kind: 'try-topic' }
  | { readonly kind: 'module-session' }
  | { readonly kind: 'call'; readonly service: ServiceName; readonly request?: object }
  | { readonly kind: 'program'; readonly action: 'run' | 'publish' | 'stop' };

export type GraphAnswer = 'wire-in' | 'wire-out' | 'mirror' | 'start';

export interface Step {
  readonly title: string;
  /** One idea, at most 60 words. Identifiers in back-quotes. */
  readonly text: string;
  /** Shown below the text. */
  readonly code?: string;
  /** One to three. */
  readonly checks: readonly Check[];
  readonly answer: Answer;
}

/** Contents beside the lesson. */
export type Workspace =
  | { readonly kind: 'topic' }
  | { readonly kind: 'graph'; readonly graph: 'mirror' | 'many-phones'; readonly phones: boolean }
  | {
      readonly kind: 'module';
      /** Code at the start of each step. */
      readonly codes: readonly string[];
    }
  | { readonly kind: 'service'; readonly services: readonly ServiceName[] }
  | { readonly kind: 'program' };

export interface Lesson {
  /** Part of the URL. */
  readonly id: string;
  /** Title in the contents. */
  readonly title: string;
  readonly heading: string;
  /** At most two sentences. */
  readonly intro: string;
  readonly minutes: number;
  readonly workspace: Workspace;
  /** At most five. */
  readonly steps: readonly Step[];
}
