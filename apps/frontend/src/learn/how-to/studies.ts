import type { HowTo } from './how-to.ts';

/** How-tos for studies, and for personal data in recordings. */
export const STUDY_HOW_TOS: readonly HowTo[] = [
  {
    id: 'run-a-study',
    title: 'Run a study',
    intro:
      'The master orders the conditions for each participant, checks the required devices, and starts and stops a recording and a session with each block.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open Recordings, choose **Studies** above its list, and choose **New study**, or **Use the example**, which needs one phone.',
          'In **Design**, enter the **Conditions**, each with the session that runs during it, and the **Order of conditions**. **Balanced** lets each condition come equally often at each place and after each other one.',
          'Enter the **Consent text**. Choose **Add required device** for each device, with the rate, battery level or clock error that it needs, and choose what to record. Everything is saved automatically.',
          'Choose **Invite devices** for the phones of participants: they join as players, who open neither studies nor recordings.',
          'In **Run**, enter a **Participant code**, a pseudonym and never a name, and choose **Start run**.',
          'Choose **Show the consent text** and hand over the device: the participant reads it and chooses **I agree**.',
          'Wait until all devices are **Ready** and choose **Start**; M marks a moment, **Stop** ends the block. Another device that joined as admin leads the same run when it opens the study, such as your phone.',
          'Choose **End run**. The list has the recordings of the run, with names such as `sub-P01_ses-1_task-LeftHand_run-01`.',
        ],
      },
      { kind: 'link', text: 'Studies', to: '/studies' },
      {
        kind: 'text',
        text: 'A block can be repeated or skipped in the list **Blocks**. When the master restarts during a run, **Continue** resumes it. Notes during a block are markers of its recording.',
      },
      {
        kind: 'text',
        text: 'Start the run when the participant before has left: a recording begins with values of its own run only. When a session needs a value that was published before, such as the brightness of the room, name its topic in **Topics with settings**.',
      },
      {
        kind: 'text',
        text: '**Participants** lists everybody who took part, by code. An admin deletes a participant of the study there: runs, consent, notes and recordings, also copies that were uploaded. The report names other recordings of the same time, which may have data of the participant. Files that people downloaded stay where they are.',
      },
    ],
  },
  {
    id: 'share-without-personal-data',
    title: 'Share a recording without personal data',
    intro:
      'Recordings keep everything as it was. When you share one, the export replaces names and ids of clients, devices and authors by pseudonyms, and treats the values that you labelled.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Once: open Recordings and choose **Personal data** below the list, then **Add label**. Enter the topics, choose the member of their values and the treatment: **Pseudonym**, **Round** or **Drop**. Choose **Save label**. This is for admins.',
          'Open a recording and choose **Export**. **Replace personal data** is on when labels apply, which the dialog lists; otherwise turn it on.',
          'Turn on **Move all times** to hide when it was recorded.',
          'Choose **Export**. You get two files: the shared one, and a key file with what each pseudonym stands for. Keep the key file apart, and never share it.',
          'For the next recording of the same people, choose **Use a key file**: they get the same pseudonyms.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'code',
        label: 'The same from the command line, with the labels in the recording',
        code: 'npm run export -- tuesday.mcap --format mcap --personal recording --key tuesday-key.json --out shared',
      },
      {
        kind: 'text',
        text: '**Download** saves the file as it is, with all names. Look into a shared file before you give it away: the code of modules stays, and so do texts that name a person in a way that no label covers.',
      },
    ],
  },
];
