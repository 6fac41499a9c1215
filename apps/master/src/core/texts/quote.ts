/** A text of a client as it may stand in a message for people: quoted, on one line, not endless. */
export function quote(text: string): string {
  const short = text.length > 120 ? `${text.slice(0, 119)}…` : text;
  return JSON.stringify(short);
}
