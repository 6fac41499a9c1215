/** Characters (UTF-16 units) of the description of an input or output: one sentence. [PM-6] */
export const MAX_IO_DESCRIPTION_CHARACTERS = 200;

/** Texts that an input is declared to understand: a list that people can still read through. [PM-7] */
export const MAX_CHOICES = 100;

/** Characters (UTF-16 units) of one of these texts: a word or a name. [PM-7] */
export const MAX_CHOICE_CHARACTERS = 100;
