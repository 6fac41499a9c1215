import type { ProcessingModule } from '@ubii/proto';

/** Adapter between two ports that do not fit. */
export type Adapter =
  /** Extracts a part of the value: `position.x`. */
  | {
      readonly kind: 'field';
      readonly label: string;
      readonly path: string;
      readonly module: ProcessingModule;
      readonly input: string;
      readonly output: string;
    }
  /** Module of the library that converts between the formats. */
  | {
      readonly kind: 'module';
      readonly label: string;
      readonly module: ProcessingModule;
      readonly input: string;
      readonly output: string;
    }
  /** Muxer that collects the topic and similar ones into a list. */
  | {
      readonly kind: 'muxer';
      readonly label: string;
      readonly topicGlob: string;
      readonly dataType: string;
    }
  /** Demuxer that distributes a list to topics. */
  | {
      readonly kind: 'demuxer';
      readonly label: string;
      readonly outputTopicFormat: string;
      readonly dataType: string;
    }
  /** Demuxer and muxer between two modules: one topic per element. */
  | {
      readonly kind: 'spread';
      readonly label: string;
      readonly outputTopicFormat: string;
      readonly topicGlob: string;
      readonly dataType: string;
    };

/** Whether a wire between two ports is possible. */
export type Fit =
  | { readonly fits: true }
  | {
      readonly fits: false;
      /** Reason, one sentence. */
      readonly reason: string;
      /** Adapters that would make it fit, best first. */
      readonly offers: readonly Adapter[];
    };
