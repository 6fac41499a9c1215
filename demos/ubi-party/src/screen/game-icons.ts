import { Camera, CircleHelp, Dices, Flag, Mountain, Timer } from '@lucide/vue';
import type { Component } from 'vue';

const ICONS: Readonly<Record<string, Component>> = {
  race: Flag,
  hill: Mountain,
  hunt: Camera,
  duel: Timer,
  quiz: CircleHelp,
};

/** The sign of a game, on chips and over the columns of the table. */
export function gameIcon(id: string): Component {
  return ICONS[id] ?? Dices;
}
