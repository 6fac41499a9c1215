const MAX_NAME = 16;

/** Without control characters and space around it, short enough for a sign under a piece. */
export function toName(text: string): string {
  return [...text.replace(/[\p{C}\s]+/gu, ' ').trim()].slice(0, MAX_NAME).join('');
}

export function distinctName(taken: readonly string[], name: string): string {
  let distinct = name;
  for (let number = 2; taken.includes(distinct); number += 1) distinct = `${name} ${number}`;
  return distinct;
}
