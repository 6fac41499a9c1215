/** What a line is drawn on; a canvas or a Path2D is one. */
export interface PathSink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/** The part of the time axis that is drawn. */
export interface TimeWindow {
  readonly startMs: number;
  readonly endMs: number;
  /** Pixels. */
  readonly width: number;
}

export interface TraceOptions {
  readonly window: TimeWindow;
  readonly toY: (value: number) => number;
  /** A value holds until the next one, as with bool. */
  readonly isStepped: boolean;
}
