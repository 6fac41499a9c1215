/** Sentence of a problem, split into subject and rest. */
export interface ProblemParts {
  readonly subject: string | undefined;
  readonly text: string;
}

/** Splits off the name at the beginning of a sentence, to show it in bold. */
export function problemParts(text: string, name: string | undefined): ProblemParts {
  if (name !== undefined && name !== '' && text.startsWith(`${name} `)) {
    return { subject: name, text: text.slice(name.length + 1) };
  }
  return { subject: name || undefined, text };
}
