//! The three pipes of a process, read and written without ever blocking on any of them.

use std::io::{self, ErrorKind, Read, Write};
use std::os::fd::AsFd;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout};
use std::time::Duration;

use rustix::event::{PollFd, PollFlags, Timespec, poll};

/// Bytes of standard error that are kept for the report.
const STDERR_KEPT: usize = 4096;

/// The three pipes of a process, none of which blocks.
pub struct Pipes {
    stdin: Option<ChildStdin>,
    input: Vec<u8>,
    written: usize,
    stdout: Reader<ChildStdout>,
    stderr: Reader<ChildStderr>,
}

impl Pipes {
    /// Takes the pipes of a process; each output has the same limit.
    ///
    /// # Errors
    /// When the process has no such pipe, or the system does not let it be read without blocking.
    pub fn of(child: &mut Child, input: Vec<u8>, limit: usize) -> io::Result<Self> {
        let missing = || io::Error::other("a pipe is missing");
        let stdin = child.stdin.take().ok_or_else(missing)?;
        let stdout = child.stdout.take().ok_or_else(missing)?;
        let stderr = child.stderr.take().ok_or_else(missing)?;
        rustix::io::ioctl_fionbio(&stdin, true)?;
        rustix::io::ioctl_fionbio(&stdout, true)?;
        rustix::io::ioctl_fionbio(&stderr, true)?;
        Ok(Self {
            stdin: Some(stdin),
            input,
            written: 0,
            stdout: Reader::new(stdout, limit, limit),
            stderr: Reader::new(stderr, limit, STDERR_KEPT),
        })
    }

    /// Whether the process can write nothing any more.
    pub fn outputs_closed(&self) -> bool {
        self.stdout.pipe.is_none() && self.stderr.pipe.is_none()
    }

    /// Whether an output has passed its limit.
    pub fn flooded(&self) -> bool {
        self.stdout.flooded() || self.stderr.flooded()
    }

    /// What was written to standard output.
    pub fn into_output(self) -> Vec<u8> {
        self.stdout.kept
    }

    /// The end of what was written to standard error.
    pub fn stderr(&self) -> String {
        String::from_utf8_lossy(&self.stderr.kept).into_owned()
    }

    /// Waits until a pipe is ready, but not longer than the given time, less than a second.
    ///
    /// # Errors
    /// When the system refuses.
    pub fn wait(&self, longest: Duration) -> io::Result<()> {
        let mut descriptors = Vec::with_capacity(3);
        if let Some(stdin) = &self.stdin {
            descriptors.push(PollFd::from_borrowed_fd(stdin.as_fd(), PollFlags::OUT));
        }
        if let Some(stdout) = &self.stdout.pipe {
            descriptors.push(PollFd::from_borrowed_fd(stdout.as_fd(), PollFlags::IN));
        }
        if let Some(stderr) = &self.stderr.pipe {
            descriptors.push(PollFd::from_borrowed_fd(stderr.as_fd(), PollFlags::IN));
        }
        let longest = Timespec { tv_sec: 0, tv_nsec: longest.subsec_nanos().into() };
        match poll(&mut descriptors, Some(&longest)) {
            Ok(_) | Err(rustix::io::Errno::INTR) => Ok(()),
            Err(error) => Err(error.into()),
        }
    }

    /// Moves what can be moved without waiting.
    pub fn transfer(&mut self) {
        self.write();
        self.stdout.read();
        self.stderr.read();
    }

    /// An implementation need not read its input: a closed pipe is no fault.
    fn write(&mut self) {
        while let Some(stdin) = &mut self.stdin {
            match stdin.write(self.input.get(self.written..).unwrap_or_default()) {
                Ok(0) => self.stdin = None,
                Ok(count) => {
                    self.written += count;
                    if self.written >= self.input.len() {
                        self.stdin = None;
                    }
                }
                Err(error) if error.kind() == ErrorKind::WouldBlock => return,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(_) => self.stdin = None,
            }
        }
    }
}

/// One output: read to its end or to the limit, the last `keep` bytes kept.
struct Reader<R> {
    pipe: Option<R>,
    limit: usize,
    keep: usize,
    count: usize,
    kept: Vec<u8>,
}

impl<R: Read> Reader<R> {
    fn new(pipe: R, limit: usize, keep: usize) -> Self {
        Self { pipe: Some(pipe), limit, keep, count: 0, kept: Vec::new() }
    }

    fn flooded(&self) -> bool {
        self.count > self.limit
    }

    fn read(&mut self) {
        let mut chunk = [0; 16 << 10];
        while let Some(pipe) = self.pipe.as_mut().filter(|_| self.count <= self.limit) {
            match pipe.read(&mut chunk) {
                Ok(0) => self.pipe = None,
                Ok(count) => self.take(chunk.get(..count).unwrap_or_default()),
                Err(error) if error.kind() == ErrorKind::WouldBlock => return,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(_) => self.pipe = None,
            }
        }
    }

    fn take(&mut self, bytes: &[u8]) {
        self.count += bytes.len();
        self.kept.extend_from_slice(bytes);
        if self.kept.len() > self.keep {
            self.kept.drain(..self.kept.len() - self.keep);
        }
    }
}
