/** Target of a path, such as a canvas or a Path2D. */
export interface PathSink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/** Visible part of the time axis. */
export interface TimeWindow {
  readonly startMs: number;
  readonly endMs: number;
  /** Pixels. */
  readonly width: number;
}

export interface TraceOptions {
  readonly window: TimeWindow;
  readonly toY: (value: number) => number;
  /** A value holds until the next one, as for bool. */
  readonly isStepped: boolean;
}
