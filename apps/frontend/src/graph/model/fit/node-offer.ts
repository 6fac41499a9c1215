import type { DataFormat, ProcessingModule } from '@ubii/proto';

/** An existing topic that can be offered. */
export interface KnownTopic {
  readonly topic: string;
  /** Data format in any spelling; empty: unknown. */
  readonly format: string;
}

/** A new node that a wire dropped on empty space would fit. */
export type NodeOffer =
  | {
      readonly kind: 'module';
      readonly label: string;
      readonly module: ProcessingModule;
      readonly port: string;
    }
  | {
      readonly kind: 'topic';
      readonly label: string;
      readonly topic: string;
      readonly isNew: boolean;
      readonly format: DataFormat | undefined;
    }
  | { readonly kind: 'muxer' | 'demuxer'; readonly label: string; readonly dataType: string }
  | { readonly kind: 'constant'; readonly label: string; readonly format: DataFormat };
