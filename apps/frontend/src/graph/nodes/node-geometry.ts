/** Dimensions of nodes, pixels at a zoom of 1, for calculations and for style sheets. */
export const NODE = {
  width: 184,
  topicWidth: 174,
  topicHeight: 70,
  /** Height of the value at the bottom of a topic node. */
  nowHeight: 27,
  pictureHeight: 88,
  pictureMargin: 6,
  head: 30,
  row: 24,
  /** Padding above and below all rows. */
  rowsPadding: 5,
  foot: 24,
  border: 1,
} as const;

/** The dimensions as CSS custom properties: `--node-row` and so on. */
export function nodeMeasures(): [name: string, value: string][] {
  return Object.entries(NODE).map(([name, pixels]) => {
    const kebab = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    return [`--node-${kebab}`, `${pixels}px`];
  });
}
