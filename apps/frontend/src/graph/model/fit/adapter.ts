import type { ProcessingModule } from '@ubii/proto';

/** What can be put between two ports that do not fit. */
export type Adapter =
  /** Takes one part of the value: `position.x`. */
  | {
      readonly kind: 'field';
      readonly label: string;
      readonly path: string;
      readonly module: ProcessingModule;
      readonly input: string;
      readonly output: string;
    }
  /** A module of the library that turns the one into the other. */
  | {
      readonly kind: 'module';
      readonly label: string;
      readonly module: ProcessingModule;
      readonly input: string;
      readonly output: string;
    }
  /** Gathers the topic, and those like it, into a list. */
  | {
      readonly kind: 'muxer';
      readonly label: string;
      readonly topicGlob: string;
      readonly dataType: string;
    }
  /** Spreads a list over topics. */
  | {
      readonly kind: 'demuxer';
      readonly label: string;
      readonly outputTopicFormat: string;
      readonly dataType: string;
    }
  /** Both: one topic for each element on the way from module to module. */
  | {
      readonly kind: 'spread';
      readonly label: string;
      readonly outputTopicFormat: string;
      readonly topicGlob: string;
      readonly dataType: string;
    };

/** Whether a wire from one port to another makes sense. */
export type Fit =
  | { readonly fits: true }
  | {
      readonly fits: false;
      /** One sentence: what is wrong. */
      readonly reason: string;
      /** What would make it fit, best first. */
      readonly offers: readonly Adapter[];
    };
