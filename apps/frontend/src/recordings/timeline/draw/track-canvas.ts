import type { Span } from '../span.ts';

/** The part of a 2D context that tracks are drawn with. */
export type Pen = Pick<
  CanvasRenderingContext2D,
  | 'beginPath'
  | 'clip'
  | 'drawImage'
  | 'fillRect'
  | 'fillStyle'
  | 'fillText'
  | 'font'
  | 'globalAlpha'
  | 'lineJoin'
  | 'lineTo'
  | 'lineWidth'
  | 'moveTo'
  | 'rect'
  | 'restore'
  | 'roundRect'
  | 'fill'
  | 'save'
  | 'setLineDash'
  | 'stroke'
  | 'strokeStyle'
  | 'textBaseline'
>;

/** Where a track is drawn. */
export interface TrackView {
  readonly span: Span;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Colours and faces of the theme in force. */
export interface TrackInk {
  /** @param css any colour, tokens included */
  color(css: string): string;
  readonly font: string;
}

export const msPerPx = ({ span, widthPx }: TrackView): number =>
  (span.untilMs - span.fromMs) / Math.max(1, widthPx);
