import sys
from compare import check_chapter, check_cases
if __name__ == "__main__":
    sys.exit(any([check_chapter(p).differ for p in sys.argv[2:]]))
