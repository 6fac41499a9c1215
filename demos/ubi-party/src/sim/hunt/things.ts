/** Something to find: a class of COCO that homes and schools have. */
export interface Thing {
  /** The class, as detectors name it. */
  readonly label: string;
  /** For people, behind `Find`; at most 11 characters. */
  readonly name: string;
}

/** By the name of the setting that leaves the thing out. */
export const THINGS = {
  cup: { label: 'cup', name: 'a cup' },
  bottle: { label: 'bottle', name: 'a bottle' },
  book: { label: 'book', name: 'a book' },
  chair: { label: 'chair', name: 'a chair' },
  keyboard: { label: 'keyboard', name: 'a keyboard' },
  mouse: { label: 'mouse', name: 'a PC mouse' },
  phone: { label: 'cell phone', name: 'a phone' },
  backpack: { label: 'backpack', name: 'a backpack' },
  scissors: { label: 'scissors', name: 'scissors' },
  clock: { label: 'clock', name: 'a clock' },
  spoon: { label: 'spoon', name: 'a spoon' },
  fork: { label: 'fork', name: 'a fork' },
  bowl: { label: 'bowl', name: 'a bowl' },
  banana: { label: 'banana', name: 'a banana' },
  apple: { label: 'apple', name: 'an apple' },
  laptop: { label: 'laptop', name: 'a laptop' },
  plant: { label: 'potted plant', name: 'a plant' },
  umbrella: { label: 'umbrella', name: 'an umbrella' },
  remote: { label: 'remote', name: 'a remote' },
  teddy: { label: 'teddy bear', name: 'a teddy' },
} as const satisfies Readonly<Record<string, Thing>>;
export type ThingId = keyof typeof THINGS;

const ALL: readonly Thing[] = Object.values(THINGS);

export function thingOf(label: string): Thing {
  return ALL.find((thing) => thing.label === label) ?? { label, name: `a ${label}` };
}
