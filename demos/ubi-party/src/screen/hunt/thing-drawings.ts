/** Paints of a drawing, from light to dark, then paper. */
export type Tone = 'light' | 'wood' | 'deep' | 'dark' | 'paper';
export type Drawing = readonly (readonly [tone: Tone, path: string])[];

const rect = (x: number, y: number, w: number, h: number, r = 12): string =>
  `M${x + r} ${y}h${w - 2 * r}a${r} ${r} 0 0 1 ${r} ${r}v${h - 2 * r}a${r} ${r} 0 0 1 ${-r} ${r}h${2 * r - w}a${r} ${r} 0 0 1 ${-r} ${-r}v${2 * r - h}a${r} ${r} 0 0 1 ${r} ${-r}z`;
const oval = (x: number, y: number, rx: number, ry = rx): string =>
  `M${x - rx} ${y}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0z`;
const keys = (): string =>
  [0, 1, 2]
    .flatMap((row) =>
      Array.from({ length: 8 }, (_, column) => rect(34 + column * 29, 116 + row * 28, 22, 20, 5)),
    )
    .join('');

/** Our own drawings of things, 300 by 300, by the class of the detector. */
export const DRAWINGS: Readonly<Record<string, Drawing>> = {
  cup: [
    ['deep', 'M206 96h30a54 54 0 0 1 0 108h-30v-30h26a25 25 0 0 0 0 -48h-26z'],
    ['light', 'M50 62V232a80 30 0 0 0 164 0V62z'],
    ['wood', 'M160 80V256a80 30 0 0 0 54 -24V62z'],
    ['paper', oval(132, 62, 82, 24)],
    ['deep', oval(132, 66, 66, 16)],
  ],
  bottle: [
    ['dark', rect(124, 14, 52, 34, 8)],
    ['light', 'M130 46h40v50q44 24 44 70v96q0 24 -24 24h-80q-24 0 -24 -24v-96q0 -46 44 -70z'],
    ['wood', 'M156 46h14v50q44 24 44 70v96q0 24 -24 24h-34z'],
    ['paper', rect(86, 170, 128, 62, 4)],
  ],
  book: [
    ['deep', rect(48, 40, 204, 226, 14)],
    ['paper', rect(64, 232, 188, 26, 6)],
    ['light', rect(48, 34, 196, 200, 14)],
    ['wood', rect(48, 34, 30, 200, 14)],
    ['deep', rect(104, 74, 108, 16, 6) + rect(104, 104, 76, 12, 6)],
  ],
  chair: [
    ['deep', rect(76, 160, 20, 122, 6) + rect(204, 160, 20, 122, 6)],
    ['light', rect(80, 20, 140, 34, 10) + rect(80, 72, 140, 28, 10)],
    ['wood', rect(80, 20, 20, 150, 8) + rect(200, 20, 20, 150, 8)],
    ['light', rect(62, 144, 176, 44, 14)],
    ['wood', rect(62, 168, 176, 22, 10)],
  ],
  keyboard: [
    ['deep', rect(14, 98, 272, 132, 18)],
    ['light', rect(14, 88, 272, 130, 18)],
    ['wood', keys()],
  ],
  mouse: [
    ['deep', 'M150 60V30Q150 12 176 14'],
    ['light', 'M150 52q70 0 70 80v56q0 82 -70 82t-70 -82v-56q0 -80 70 -80z'],
    ['wood', 'M150 52q70 0 70 80v8h-70z'],
    ['deep', rect(140, 84, 20, 52, 10)],
  ],
  'cell phone': [
    ['deep', rect(86, 18, 140, 268, 24)],
    ['light', rect(76, 12, 140, 268, 24)],
    ['wood', rect(90, 40, 112, 206, 6)],
    ['deep', rect(122, 256, 48, 10, 5)],
  ],
  backpack: [
    ['dark', 'M116 62q0 -44 34 -44t34 44h-18q0 -26 -16 -26t-16 26z'],
    ['deep', rect(42, 150, 40, 108, 18) + rect(218, 150, 40, 108, 18)],
    ['light', 'M66 142q0 -90 84 -90t84 90v110q0 30 -30 30H96q-30 0 -30 -30z'],
    ['wood', rect(92, 176, 116, 82, 18)],
    ['deep', rect(92, 190, 116, 12, 4) + rect(104, 112, 92, 12, 6)],
  ],
  scissors: [
    ['light', 'M96 20L186 196l-24 16L78 40z'],
    ['wood', 'M204 20L114 196l24 16L222 40z'],
    [
      'deep',
      `${oval(106, 236, 44)}${oval(106, 236, 24)}${oval(194, 236, 44)}${oval(194, 236, 24)}`,
    ],
    ['dark', oval(150, 140, 10)],
  ],
  clock: [
    ['deep', oval(156, 158, 122)],
    ['light', oval(150, 150, 122)],
    ['paper', oval(150, 150, 98)],
    ['dark', rect(143, 78, 14, 80, 7) + rect(146, 143, 66, 14, 7) + oval(150, 150, 13)],
  ],
  spoon: [
    ['wood', rect(138, 130, 24, 156, 12)],
    ['light', oval(150, 84, 52, 70)],
    ['wood', oval(156, 90, 36, 52)],
  ],
  fork: [
    ['wood', rect(138, 140, 24, 146, 12)],
    ['light', 'M104 16h16v92h22V16h16v92h22V16h16v110q0 36 -46 36t-46 -36z'],
  ],
  bowl: [
    ['deep', rect(104, 232, 92, 30, 10)],
    ['light', 'M26 112h248q0 136 -124 136T26 112z'],
    ['wood', 'M180 112h94q0 136 -124 136q60 -30 30 -136z'],
    ['paper', oval(150, 112, 124, 30)],
    ['deep', oval(150, 116, 102, 20)],
  ],
  banana: [
    ['light', 'M52 46q28 166 190 168q24 0 24 22q0 14 -24 18Q36 282 26 62z'],
    ['wood', 'M26 62Q36 282 242 254q12 -2 18 -8Q60 262 40 54z'],
    ['dark', rect(26, 26, 28, 38, 8)],
  ],
  apple: [
    ['dark', 'M142 84q-6 -44 18 -66l14 12q-18 18 -14 54z'],
    [
      'light',
      'M150 84q30 -24 66 -10q50 22 40 92q-14 106 -66 112q-20 0 -40 -10q-20 10 -40 10q-52 -6 -66 -112q-10 -70 40 -92q36 -14 66 10z',
    ],
    ['wood', 'M216 74q50 22 40 92q-14 106 -66 112q-10 0 -20 -4q70 -60 46 -200z'],
  ],
  laptop: [
    ['light', rect(46, 48, 208, 150, 14)],
    ['deep', rect(62, 64, 176, 118, 4)],
    ['wood', 'M20 206h260l14 34q2 12 -12 12H18q-14 0 -12 -12z'],
    ['light', rect(116, 212, 68, 12, 4)],
  ],
  'potted plant': [
    ['deep', 'M144 176q-90 -10 -104 -104q84 6 110 70q10 -96 90 -120q20 100 -76 154z'],
    ['wood', 'M150 176q0 -80 80 -104q-30 20 -66 104z'],
    ['light', 'M84 176h132l-18 104q-2 10 -12 10h-72q-10 0 -12 -10z'],
    ['wood', rect(72, 164, 156, 36, 10)],
  ],
  umbrella: [
    ['dark', 'M143 40h14v200q0 40 -38 40t-38 -36h16q0 20 22 20t24 -26z'],
    [
      'light',
      'M22 164q8 -116 128 -120q120 4 128 120q-30 -30 -62 0q-32 -30 -66 0q-34 -30 -66 0q-32 -30 -62 0z',
    ],
    ['wood', 'M150 44q120 4 128 120q-30 -30 -62 0q-6 -90 -66 -120z'],
  ],
  remote: [
    ['deep', rect(106, 18, 104, 272, 26)],
    ['light', rect(96, 12, 104, 272, 26)],
    ['dark', oval(148, 54, 18)],
    ['wood', [100, 142, 184, 226].map((y) => oval(124, y, 13) + oval(172, y, 13)).join('')],
  ],
  'teddy bear': [
    ['wood', oval(88, 60, 34) + oval(212, 60, 34) + oval(78, 214, 40) + oval(222, 214, 40)],
    ['light', oval(150, 218, 76, 68) + oval(150, 106, 82, 76)],
    ['paper', oval(150, 132, 36, 28)],
    ['dark', oval(118, 94, 9) + oval(182, 94, 9) + oval(150, 122, 13, 9)],
  ],
};
