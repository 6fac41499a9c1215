import type { PlayerShape } from './player-identity.ts';

/** Outlines of marks in a box of 24 by 24 units. */
export const OUTLINES: Record<PlayerShape, string> = {
  circle: 'M12 1a11 11 0 1 1 0 22a11 11 0 0 1 0-22z',
  triangle: 'M12 1.6L23.6 22.4H.4z',
  square: 'M2.5 2.5h19v19h-19z',
  star: 'M12 .6l3.3 7.3 8 .9-6 5.3 1.7 7.8L12 17.9l-7 4 1.7-7.8-6-5.3 8-.9z',
  diamond: 'M12 .5L23.5 12 12 23.5.5 12z',
  cross: 'M7.5 1h9v6.5H23v9h-6.5V23h-9v-6.5H1v-9h6.5z',
  hexagon: 'M12 .8l9.7 5.6v11.2L12 23.2 2.3 17.6V6.4z',
  drop: 'M12 .5c4.5 5.5 8.5 9.2 8.5 14a8.5 8.5 0 0 1-17 0c0-4.8 4-8.5 8.5-14z',
  ring: 'M12 1a11 11 0 1 1 0 22a11 11 0 0 1 0-22z',
  moon: 'M15.5 1.2A11.5 11.5 0 1 0 22.8 16A11.5 11.5 0 0 1 15.5 1.2z',
  flower:
    'M12 1a4.7 4.7 0 0 1 4.6 4.2A4.7 4.7 0 0 1 22.3 11.5a4.7 4.7 0 0 1-2.2 6.9a4.7 4.7 0 0 1-8.1 3.1a4.7 4.7 0 0 1-8.1-3.1A4.7 4.7 0 0 1 1.7 11.5A4.7 4.7 0 0 1 7.4 5.2A4.7 4.7 0 0 1 12 1z',
  heart: 'M12 22.5C4 16.5 1 12.5 1 8a5.8 5.8 0 0 1 11-2.6A5.8 5.8 0 0 1 23 8c0 4.5-3 8.5-11 14.5z',
};
