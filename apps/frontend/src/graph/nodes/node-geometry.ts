/** Measures of nodes, pixels at a zoom of 1: for what computes with them, and for the style sheets of nodes. */
export const NODE = {
  width: 184,
  topicWidth: 174,
  topicHeight: 70,
  /** Value of a topic, at the bottom of its node. */
  nowHeight: 27,
  pictureHeight: 88,
  pictureMargin: 6,
  head: 30,
  row: 24,
  /** Above and below all rows. */
  rowsPadding: 5,
  foot: 24,
  border: 1,
} as const;

/** The measures as properties of style sheets: `--node-row` and so on. */
export function nodeMeasures(): [name: string, value: string][] {
  return Object.entries(NODE).map(([name, pixels]) => {
    const kebab = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    return [`--node-${kebab}`, `${pixels}px`];
  });
}
