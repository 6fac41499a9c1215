import type { DataFormatFamily } from '@ubii/proto';

/** Shape of a family's socket as SVG paths in a box of 12 units, and the second outline for lists. */
export interface SocketShape {
  /** Outline; filled when the socket carries data, unless there is a `core`. */
  readonly outline: string;
  /** Filled instead of the outline when the socket carries data. */
  readonly core?: string;
  /** Drawn behind, to the right, for lists. */
  readonly echo: string;
}

const SQUARE_ECHO = 'M12.6 1.9h1.4v8.2h-1.4';

export const SOCKET_SHAPES: Readonly<Record<DataFormatFamily, SocketShape>> = {
  number: {
    outline: 'M6 1.9a4.1 4.1 0 1 1 0 8.2a4.1 4.1 0 1 1 0-8.2z',
    echo: 'M9.9 1.3a5.9 5.9 0 0 1 0 9.4',
  },
  vector: {
    outline: 'M2 1.6L10.2 6L2 10.4z',
    echo: 'M7.4 1.5L14.6 6L7.4 10.5',
  },
  rotation: {
    outline: 'M6 1.2L10.8 6L6 10.8L1.2 6z',
    echo: 'M9.7 1.6L14.1 6L9.7 10.4',
  },
  event: {
    outline: 'M1.9 1.9h4.2a4.1 4.1 0 0 1 0 8.2h-4.2z',
    echo: 'M9.6 1.3a5.7 5.7 0 0 1 0 9.4',
  },
  text: {
    outline: 'M2 2h8v8h-8z',
    echo: SQUARE_ECHO,
  },
  image: {
    outline: 'M1.5 1.5h9v9h-9z',
    core: 'M4.1 4.1h3.8v3.8h-3.8z',
    echo: SQUARE_ECHO,
  },
  objects: {
    outline: 'M1.5 3.9V1.5H3.9M8.1 1.5h2.4V3.9M10.5 8.1v2.4H8.1M3.9 10.5H1.5V8.1',
    core: 'M4.3 4.3h3.4v3.4h-3.4z',
    echo: 'M14 3.9V1.5h-1.4M14 8.1v2.4h-1.4',
  },
  pose: {
    outline: 'M6 1.1L10.2 3.5V8.5L6 10.9L1.8 8.5V3.5z',
    echo: 'M10.4 1.7L13.9 3.8V8.2L10.4 10.3',
  },
  system: {
    outline: 'M6 2.2v7.6M2.2 6h7.6',
    echo: 'M12.6 3.9v4.2',
  },
};
