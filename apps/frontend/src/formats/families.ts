import {
  Braces,
  Diamond,
  Hash,
  Image,
  MoveUpRight,
  PersonStanding,
  Rotate3d,
  Scan,
  Zap,
} from '@lucide/vue';
import { DATA_FORMATS, parseDataFormat, type DataFormat, type DataFormatFamily } from '@ubii/proto';
import type { Component } from 'vue';

/** Properties that distinguish a family of data formats besides colour and shape. */
export interface FamilyLook {
  readonly name: string;
  readonly letter: string;
  readonly icon: Component;
}

export const FAMILIES: Readonly<Record<DataFormatFamily, FamilyLook>> = {
  number: { name: 'Numbers', letter: '#', icon: Hash },
  vector: { name: 'Vectors', letter: 'v', icon: MoveUpRight },
  rotation: { name: 'Rotations', letter: 'R', icon: Rotate3d },
  event: { name: 'Events', letter: '!', icon: Zap },
  text: { name: 'Text', letter: 'T', icon: Braces },
  image: { name: 'Images', letter: 'I', icon: Image },
  objects: { name: 'Objects', letter: 'O', icon: Scan },
  pose: { name: 'Poses', letter: 'P', icon: PersonStanding },
  system: { name: 'System', letter: 'S', icon: Diamond },
};

/** Display of the message format of a component or topic. */
export interface FormatLook {
  /** `undefined` for a format that this program does not know. */
  readonly format: DataFormat | undefined;
  readonly family: DataFormatFamily;
  readonly isList: boolean;
  /** Short name for display, or the unknown text itself. */
  readonly text: string;
}

/** Parses a format in any spelling that occurs (`vector2`, `ubii.dataStructure.Vector2`, `boolean`). */
export function formatLook(text: string): FormatLook {
  const format = parseDataFormat(text);
  if (format === undefined) return { format, family: 'system', isList: false, text };
  const { family, isList } = DATA_FORMATS[format];
  return { format, family, isList, text: format };
}
